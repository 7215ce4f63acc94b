# SPDX-License-Identifier: BSD-3-Clause
"""Ports repositories from the wild and compares original and port; the program behind scripts/port-packages."""
