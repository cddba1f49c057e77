# The Debian packages each script needs, and how they are installed. Sourced by quickstart and check.

# What the program needs, and what its tests need beside it. CGAL is no part of the program: it makes the peers, and is an
# outside oracle of the tests.
core_packages=(
  g++ cmake ninja-build pkg-config
  libgmp-dev libsqlite3-dev libpng-dev
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libbenchmark-dev
  libcgal-dev
)
test_packages=(libgtest-dev libboost-dev)
# Not installed by any script: libnetcdf-dev and gmt-gshhg-{low,high,full}, for the datasets that docs/datasets.md says are read
# from the user's system.
full_packages=(clang-14 clang-tidy-14 clang-format-14 libclang-rt-14-dev)

# install_packages PACKAGE...: installs what is missing, says so, and fails with what to type when it may not.
install_packages() {
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  if [[ ${no_install:-0} == 1 ]]; then
    echo "missing packages: ${missing[*]} (run without --no-install, or: apt-get install ${missing[*]})" >&2
    return 2
  fi
  local sudo=()
  ((EUID == 0)) || sudo=(sudo)
  echo "installing ${#missing[@]} packages: ${missing[*]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# install_charts: the chart libraries of the report, pinned by package-lock.json. Without npm or a network the report
# keeps its static figures and tables.
install_charts() {
  [[ -f package-lock.json ]] || return 0
  [[ -d node_modules/vega && -d node_modules/vega-lite && -d node_modules/vega-embed ]] && return 0
  if [[ ${no_install:-0} == 1 ]]; then
    echo "charts: left out (--no-install and no node_modules); the report keeps static figures"
    return 0
  fi
  command -v npm >/dev/null || install_packages npm || true
  if command -v npm >/dev/null && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >/dev/null; then
    echo "charts: vega, vega-lite and vega-embed installed"
  else
    echo "charts: left out (npm could not install them); the report keeps static figures"
  fi
}

step() { printf '\n== %s (%ds)\n' "$1" "$SECONDS"; }
