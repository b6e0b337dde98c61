#!/usr/bin/env bash
# Installs what the tests of tests/peers compare with: ParaView with its Python, MPI, and vtk.js from npm (into
# build/peers). As root, on Debian 12.
set -euo pipefail
root=$(readlink -f "$(dirname "$0")/../..")
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends paraview python3-paraview openmpi-bin python3-numpy xvfb
if command -v npm >/dev/null; then npm install --silent --no-audit --no-fund --prefix "$root/build/peers" @kitware/vtk.js; fi
