# The checksum here is none: script/release writes a copy with that of the release.
vcpkg_download_distfile(ARCHIVE
    URLS "https://github.com/vtkwater/vtkwater/releases/download/v${VERSION}/vtkwater-${VERSION}-source.tar.gz"
    FILENAME "vtkwater-${VERSION}-source.tar.gz"
    SHA512 0
)
vcpkg_extract_source_archive(SOURCE_PATH
    ARCHIVE "${ARCHIVE}"
)

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        -DBUILD_TESTING=OFF
        -DWATER_BUILD_EXAMPLES=OFF
        -DWATER_WRAP_PYTHON=OFF
        -DWATER_RELOCATABLE=ON
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME vtkwater CONFIG_PATH lib/cmake/vtkWater)
vcpkg_fixup_pkgconfig()
vcpkg_copy_pdbs()

file(REMOVE_RECURSE
    "${CURRENT_PACKAGES_DIR}/debug/include"
    "${CURRENT_PACKAGES_DIR}/debug/share"
    "${CURRENT_PACKAGES_DIR}/share/licenses"
)
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
