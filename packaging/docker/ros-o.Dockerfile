# SPDX-License-Identifier: BSD-3-Clause
# TZC on ROS-O (Ubuntu 24.04 or 22.04). Untested: see packaging/README.md.
#   docker build -f packaging/docker/ros-o.Dockerfile -t tzc:ros-o .
ARG UBUNTU=24.04
FROM ubuntu:${UBUNTU}
SHELL ["/bin/bash", "-o", "pipefail", "-c"]
ENV DEBIAN_FRONTEND=noninteractive
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates curl gnupg lsb-release \
 && curl -fsSL https://ros.packages.techfak.net/gpg.key -o /etc/apt/keyrings/ros-one.asc \
 && echo "deb [signed-by=/etc/apt/keyrings/ros-one.asc] https://ros.packages.techfak.net $(lsb_release -cs) main" \
    >/etc/apt/sources.list.d/ros-one.list \
 && if [ "$(lsb_release -rs)" = 22.04 ]; then \
      curl -fsSL https://apt.llvm.org/llvm-snapshot.gpg.key -o /etc/apt/keyrings/llvm.asc; \
      echo "deb [signed-by=/etc/apt/keyrings/llvm.asc] http://apt.llvm.org/jammy/ llvm-toolchain-jammy-16 main" \
        >/etc/apt/sources.list.d/llvm.list; \
    fi \
 && rm -rf /var/lib/apt/lists/*
COPY . /opt/tzc-source
RUN /opt/tzc-source/scripts/setup && rm -rf /var/lib/apt/lists/*
RUN source /opt/ros/one/setup.bash \
 && cmake -G Ninja -S /opt/tzc-source -B /tmp/build -DTZC_BUILD_TESTS=OFF -DTZC_BUILD_BENCH=OFF \
 && cmake --build /tmp/build && cmake --install /tmp/build --prefix /opt/tzc && rm -rf /tmp/build
RUN echo 'source /opt/tzc/setup.bash' >>/etc/bash.bashrc
