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
# Ubuntu 20.04 has no libcli11-dev; it is one folder of headers.
ARG CLI11=2.3.2
RUN wget -qO- "https://github.com/CLIUtils/CLI11/archive/refs/tags/v$CLI11.tar.gz" | tar -xz -C /tmp \
 && cmake -S "/tmp/CLI11-$CLI11" -B /tmp/cli11 -DCLI11_BUILD_TESTS=OFF -DCLI11_BUILD_EXAMPLES=OFF \
 && cmake --install /tmp/cli11 && rm -rf /tmp/cli11 "/tmp/CLI11-$CLI11"
RUN source /opt/ros/noetic/setup.bash \
 && cmake -G Ninja -S /opt/tzc-source -B /tmp/build -DTZC_BUILD_TESTS=OFF -DTZC_BUILD_BENCH=OFF \
 && cmake --build /tmp/build && cmake --install /tmp/build --prefix /opt/tzc && rm -rf /tmp/build
RUN echo 'source /opt/tzc/setup.bash' >>/etc/bash.bashrc
