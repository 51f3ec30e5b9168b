# SPDX-License-Identifier: BSD-3-Clause
# A machine that runs script/demo and script/test:
#
#   docker build -t vtkwater-dev .
#   docker run --rm -it -v "$PWD:/src/vtkwater" vtkwater-dev script/demo
#
# The build installs what script/bootstrap lists, and PyPI's VTK is set up at the first script/test.
FROM debian:bookworm
COPY script /tmp/bootstrap/script
RUN WATER_SKIP_VTK96=1 bash /tmp/bootstrap/script/bootstrap test \
  && apt-get install --no-install-recommends -y git libosmesa6 python3-venv clang-format-14 \
  && rm -rf /var/lib/apt/lists/* /tmp/bootstrap
WORKDIR /src/vtkwater
