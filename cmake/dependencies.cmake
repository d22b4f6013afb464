# Every library that tetralux uses, by the Debian package that holds it (see tools/packages.txt).
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)            # libfmt-dev
find_package(spdlog REQUIRED)         # libspdlog-dev
find_package(glm REQUIRED)            # libglm-dev
find_package(pugixml REQUIRED)        # libpugixml-dev
find_package(nlohmann_json REQUIRED)  # nlohmann-json3-dev
find_package(CLI11 REQUIRED)          # libcli11-dev
find_package(OpenEXR REQUIRED QUIET)  # libopenexr-dev (quiet: it notes the absence of its Python module)
find_package(PNG REQUIRED)            # libpng-dev
find_package(ZLIB REQUIRED)           # zlib1g-dev
find_package(LibLZMA REQUIRED)        # liblzma-dev
find_package(VulkanHeaders REQUIRED)   # libvulkan-dev: volk loads the entry points at run time
find_package(PkgConfig REQUIRED)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)  # liblz4-dev
find_path(VOLK_INCLUDE_DIR volk.h REQUIRED)             # libvulkan-volk-dev: header only here
