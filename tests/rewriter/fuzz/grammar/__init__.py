# SPDX-License-Identifier: BSD-3-Clause
"""Random small roscpp programs, made of the patterns that real packages are made of."""
