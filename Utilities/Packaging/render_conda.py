# SPDX-License-Identifier: BSD-3-Clause
"""Renders a recipe of conda-forge with rattler-build, for each platform that it is for.

usage: render_conda.py RECIPE      of a Python that has py-rattler-build
"""
import sys

from rattler_build import PlatformConfig, RenderConfig, Stage0Recipe, VariantConfig

PLATFORMS = ("linux-64", "linux-aarch64", "osx-64", "osx-arm64")
VARIANT = {"python": ["3.12.* *_cpython"], "c_compiler": ["gcc"], "cxx_compiler": ["gxx"], "c_stdlib": ["sysroot"]}


def main():
    recipe = Stage0Recipe.from_file(sys.argv[1])
    for platform in PLATFORMS:
        config = RenderConfig(platform=PlatformConfig(target_platform=platform, build_platform="linux-64"))
        for rendered in recipe.render(VariantConfig(variants=VARIANT), config):
            package, host = rendered.recipe.package, rendered.recipe.requirements.host
            if not any(str(item).startswith("vtk-base") for item in host):
                sys.exit(f"{platform}: no VTK to build against in {host}")
            print(f"{platform}: {package.name} {package.version}, built with {', '.join(map(str, host))}")


if __name__ == "__main__":
    main()
