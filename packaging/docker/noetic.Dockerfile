# SPDX-License-Identifier: BSD-3-Clause
# TZC on ROS Noetic (Ubuntu 20.04), LLVM from its own archive. Untested: see packaging/README.md.
#   docker build -f packaging/docker/noetic.Dockerfile -t tzc:noetic .
FROM ros:noetic-ros-base-focal
SHELL ["/bin/bash", "-o", "pipefail", "-c"]
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates wget gnupg \
 && wget -qO /usr/share/keyrings/llvm.asc https://apt.llvm.org/llvm-snapshot.gpg.key \
 && echo "deb [signed-by=/usr/share/keyrings/llvm.asc] http://apt.llvm.org/focal/ llvm-toolchain-focal-16 main" \
    >/etc/apt/sources.list.d/llvm.list \
 && rm -rf /var/lib/apt/lists/*
COPY . /opt/tzc-source
RUN /opt/tzc-source/scripts/setup && rm -rf /var/lib/apt/lists/*
# Ubuntu 20.04 has no libcli11-dev, fmt 6 and nlohmann-json 3.7 (cmake/TzcToolLibraries.cmake says what is needed): the
# versions of Debian 12, below /usr/local, where CMake looks first.
ARG LIBRARIES="CLIUtils/CLI11/archive/refs/tags/v2.3.2 fmtlib/fmt/archive/refs/tags/9.1.0 nlohmann/json/archive/refs/tags/v3.11.2"
RUN for library in $LIBRARIES; do \
      mkdir /tmp/library && wget -qO- "https://github.com/$library.tar.gz" | tar -xz -C /tmp/library --strip-components=1 \
      && cmake -G Ninja -S /tmp/library -B /tmp/library/build -DCMAKE_BUILD_TYPE=Release -DCLI11_BUILD_TESTS=OFF \
         -DCLI11_BUILD_EXAMPLES=OFF -DFMT_TEST=OFF -DFMT_DOC=OFF -DJSON_BuildTests=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
      && cmake --build /tmp/library/build && cmake --install /tmp/library/build && rm -rf /tmp/library || exit 1; \
    done
RUN source /opt/ros/noetic/setup.bash \
 && cmake -G Ninja -S /opt/tzc-source -B /tmp/build -DTZC_BUILD_TESTS=OFF -DTZC_BUILD_BENCH=OFF \
 && cmake --build /tmp/build && cmake --install /tmp/build --prefix /opt/tzc && rm -rf /tmp/build
RUN echo 'source /opt/tzc/setup.bash' >>/etc/bash.bashrc
