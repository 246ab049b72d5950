#!/bin/sh
# Seiche's errands. `./do` alone lists them.
set -eu
cd "$(dirname "$0")"

# The one list of Debian packages: what building and running need, then what only tests, benchmarks, formatting or checks need.
build_packages="g++ cmake ninja-build libvtk9-dev libosmesa6-dev libglew-dev libeigen3-dev libsuitesparse-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpng-dev fonts-dejavu-core ffmpeg"
test_packages="libgtest-dev chromium"
bench_packages="libbenchmark-dev"
format_packages="clang-format"
tidy_packages="clang-tidy libomp-dev"

usage() {
  cat <<'TEXT'
usage: ./do VERB

  deps     install the Debian packages that building and running need (root or sudo)
  build    deps, then configure (Release, Ninja) and build into build/
  demo     build, then run scenes/pan2008.toml and say where its movie is
  test     build with tests and benchmarks, then run all tests through CTest
  bench    build with benchmarks, then run them into out/bench/; './do bench quick' takes a minute
  gallery  build, then make the small pictures of scenes/gallery/ anew; some minutes
  sanitize build the solver's tests with AddressSanitizer and UndefinedBehaviorSanitizer, and run its unit tests
  tidy     look for bugs and old idioms in all sources, or in those named (clang-tidy); half an hour for all
  keys     build, then write the tables of keys in scenes/README.md anew
  format   rewrite the sources in the house style (clang-format)
  clean    remove build/, build-*/ and out/
TEXT
}

# Installs those of the named packages that are missing; asks for nothing when all are there.
install_packages() {
  missing=""
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -eq 0 ]; then
    as_root=""
  elif command -v sudo >/dev/null; then
    as_root="sudo"
  else
    echo "do: these Debian packages are missing and neither root nor sudo is at hand to install them:$missing" >&2
    exit 1
  fi
  echo "do: installing$missing"
  $as_root apt-get update -qq
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
}

build() {
  cmake --preset release -DSEICHE_TESTS="$1" -DSEICHE_BENCH="$2"
  cmake --build --preset release
}

# Threads wait as in `seiche` itself (apps/launcher.cpp).
bench() {
  export OMP_WAIT_POLICY=passive GOMP_SPINCOUNT=300
  build/tests/bench/bench_runs out/bench $1
  small=""
  [ -z "$1" ] || small="--benchmark_filter=-particles:200000 --benchmark_min_time=0.1"
  build/tests/bench/bench_parts --benchmark_out=out/bench/parts.csv --benchmark_out_format=csv $small
}

# Runs a scene up to the time of a picture, ten frames a second, and keeps the last. What else is said are its settings.
picture() {
  name="$1" scene="$2" time="$3"
  shift 3
  build/seiche run "scenes/$scene.toml" -o "out/gallery/$name" --overwrite --set time.end="$time" \
    --set output.frame_rate=10 --set output.size=576x324 --set output.movie=none --set output.vtu=false \
    --set output.report=false "$@"
  cp "out/gallery/$name/frames/$(ls "out/gallery/$name/frames" | tail -n 1)" "scenes/gallery/$name.png"
}

gallery() {
  picture dam-break dam-break 0.2 --spacing 0.0028575 --set look.quantity=speed --set look.range=0,2 --set look.curves=none
  picture splash dam-break 0.6 --spacing 0.0028575 --set look.background=black --set look.colour_map=cividis \
    --set look.quantity=speed --set look.range=0,2 --set look.curves=none
  picture bore sway-shallow 4.4 --spacing 0.00625 --set look.curves=none
  picture arrows roll 1.9 --spacing 0.01 --set look.arrows=true --set look.quantity=speed --set look.range=0,0.2 \
    --set look.curves=none
  picture smooth pan2008 2.9 --spacing 0.01 --set look.style=smooth
  picture box quick 0.6 --set tank.width=0.2
  picture membrane membrane 17 --set look.style=smooth --set look.curves=none
  picture tanker tanker 2.4 --set look.style=smooth --set look.curves=none
  picture lying-cylinder lying-cylinder 2.3 --set look.curves=none
  picture baffles baffles 2 --set look.quantity=vorticity --set look.range=-20,20 --set look.curves=none
  picture sphere sphere 2.4 --set look.curves=none
  picture upright-cylinder upright-cylinder 2.5 --set look.curves=none
  picture ringed ringed 2.5 --set look.curves=none
  picture rocket rocket 3 --set look.curves=none
  picture ship ship 22 --set output.frame_rate=2 --set look.curves=none
  picture orbit orbit 6.5 --set look.curves=none
  picture stl-tank stl-tank 1.5 --set look.curves=none
  picture spheric10 spheric10 2.5 --set look.quantity=speed --set look.range=0,1 --set look.curves=none
  build/seiche compare scenes/pan2008-paper.toml --vary method.kernel=KF1,KF2,KF3,KF4,KF5 --spacing 0.01 \
    --size 960x540 -o out/gallery/kernels --overwrite
  cp "out/gallery/kernels/frames/$(ls out/gallery/kernels/frames | tail -n 1)" scenes/gallery/kernels.png
}

case "${1:-}" in
  "" | help | -h | --help) usage ;;
  deps) install_packages $build_packages ;;
  build)
    install_packages $build_packages
    build OFF OFF
    ;;
  demo)
    install_packages $build_packages
    build OFF OFF
    build/seiche run scenes/pan2008.toml --overwrite
    ;;
  test)
    install_packages $build_packages $test_packages $bench_packages
    build ON ON  # benchmarks are compiled, so that they go on compiling, and not run
    ctest --preset release
    ;;
  sanitize)
    install_packages $build_packages $test_packages
    cmake --preset sanitize
    cmake --build --preset sanitize --target test_solver test_allocation
    ctest --preset sanitize
    ;;
  tidy)
    install_packages $build_packages $test_packages $bench_packages $tidy_packages
    shift
    cmake --preset tidy
    { [ $# -eq 0 ] && git ls-files '*.cpp' || printf '%s\n' "$@"; } |
      xargs -P "$(nproc)" -n 1 clang-tidy -p build-tidy --quiet
    ;;
  bench)
    if [ "${2:-quick}" != quick ]; then
      echo "do: bench stands alone or before 'quick', not before '$2'" >&2
      exit 2
    fi
    install_packages $build_packages $test_packages $bench_packages
    build OFF ON
    bench "${2:-}"
    ;;
  gallery)
    install_packages $build_packages
    build OFF OFF
    gallery
    ;;
  keys)
    install_packages $build_packages
    build OFF OFF
    tests/structure/keys.sh build/seiche scenes/README.md --write
    ;;
  format)
    install_packages $format_packages
    git ls-files '*.hpp' '*.cpp' | xargs clang-format -i
    ;;
  clean) rm -rf build build-* out ;;
  *)
    echo "do: there is no verb '$1'" >&2
    usage >&2
    exit 2
    ;;
esac
