# shellcheck shell=bash
# The steps of nightly.sh, each a function. Sourced at the root, after build.sh.

# The steps in their order, each with what it does.
# shellcheck disable=SC2034  # nightly.sh goes through them
steps=(
    'tests        the whole suite, as test.sh runs it, but long; builds the benchmarks'
    'mutants      programs that round wrongly are found out'
    'pictures     the documents show what the program draws'
    'alone        each header and test includes what it uses'
    'tidy         clang-tidy over the whole program'
    'avx2         the suite on registers of 32 bytes'
    'sse4         the suite on registers of 16 bytes'
    'random       long random runs: kernels, forms, rays, machine code, long texts'
    'exhaustive   every float through every elementary function'
    'lean         builds without FFmpeg and GDCM, and its tests'
    'asan         the suite under AddressSanitizer and UndefinedBehaviorSanitizer'
    'texts        the fuzzer of texts, with and without sanitizers'
    'files        the fuzzer of all readers of files, with and without sanitizers'
    'window       random input to the real window, with sanitizers'
    'tsan         the suite under ThreadSanitizer'
)
fuzz_s=${ZEROSET_FUZZ_SECONDS:-600}  # for each run of a fuzzer

# Runs ctest in a build's folder. Scripts of the real window time out under sanitizers.
suite() {
    local folder=$1
    shift
    ctest --test-dir "$folder" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
}
build_preset() {
    cmake --preset "$1"
    cmake --build --preset "$1"
}
# Where a window is driven by its timing, or time is measured to choose, sanitizers are too slow.
timed='^(pipeline/code_choice|window|window_input|window_state|user_tasks|portal|gallery_pictures|drawings|command_line|without_ffmpeg)$'
# oneTBB, LLVM and Mesa are not built with sanitizers; GDCM and Mesa leak by themselves.
sanitizer_options() {
    export ASAN_OPTIONS=detect_stack_use_after_return=0:allocator_may_return_null=1
    export LSAN_OPTIONS=suppressions=$PWD/tests/lsan.txt:print_suppressions=0
    export UBSAN_OPTIONS=print_stacktrace=1
    export TSAN_OPTIONS=halt_on_error=0:second_deadlock_stack=1:suppressions=$PWD/tests/tsan.txt
    ulimit -s 65536  # with sanitizers a formula nested as deep as it may be takes more than 8 MB
}
released=build/release/tests

step_tests() {
    ZEROSET_LONG=1 ./test.sh
    cmake --build --preset test --target benchmarks
}
step_mutants() {
    cmake --build --preset test --target mutants
    suite build/release -C mutants -R '^mutants/'
}
step_pictures() {
    cmake --build --preset test --target zeroset
    scripts/pictures.py --check build/release/zeroset
}
step_alone() {
    local files
    # The tidy step reads each of the program's sources by itself. For headers that lead to LLVM's it
    # does not know where these are.
    mapfile -t files < <(git ls-files '*.hpp' 'tests/*.cpp' ':!*-inl.hpp' ':!jit/llvm/*.hpp' \
        ':!tests/bench/plain_algebra.hpp')
    scripts/tidy.sh --alone "${files[@]}"
}
step_tidy() { scripts/tidy.sh; }
step_avx2() { ZEROSET_WIDEST=32 suite build/release; }
step_sse4() { ZEROSET_WIDEST=16 suite build/release; }
step_random() {
    local seed=$RANDOM  # others each time, as many short runs see more than one long run again
    printf 'seed %s\n' "$seed"
    "$released/inclusion_checks" --checks 10000000 --seed "$seed"
    "$released/inclusion_checks" --forms 1 --checks 2000000 --seed "$seed"
    ZEROSET_FORMULAS=5000 "$released/oracle_tests" --gtest_filter='KernelInclusion*'
    ZEROSET_FORMULAS=500 "$released/jit_tests" --gtest_filter='*HasTheInterpretersBits*'
    ZEROSET_FORMULAS=50 "$released/oracle_tests" --gtest_filter='-KernelInclusion*'
    "$released/ray_checks" --rays 300 --edges 300 --surfaces 100 --seed "$seed"
    "$released/ray_checks" --cut 1 --gallery 0 --rays 300 --edges 300 --surfaces 100 --seed "$seed"
    "$released/ray_checks" --size 512 --dstop 22 --surfaces 100 --rays 300 --edges 300 --bits 21 \
        --seed "$seed" beams
}
step_exhaustive() { "$released/elementary_exhaustive"; }
step_lean() {
    cmake --preset test -B build/lean -D ZEROSET_FFMPEG=OFF -D ZEROSET_GDCM=OFF
    cmake --build build/lean --target zeroset document_tests
    suite build/lean -R '^document/'
    build/lean/zeroset render 'x^2 + y^2 + z^2 = 1' -o build/lean/sphere.png
}
step_asan() {
    sanitizer_options
    build_preset asan
    suite build/asan -E "$timed"
}
step_texts() {
    sanitizer_options
    build_preset asan
    "$released/language_fuzz" --seconds "$fuzz_s" --seed "$RANDOM" --timeout 60
    mkdir -p build/nightly/corpus
    build/asan/tests/language_fuzzer -dict=tests/fuzz/language.dict -max_total_time="$fuzz_s" \
        -timeout=60 -rss_limit_mb=8000 -artifact_prefix=build/nightly/ \
        build/nightly/corpus tests/fuzz/corpus
}
# Makes a file of each kind that is read, by the program and by a script.
make_files() {
    local to=$1 zeroset=build/release/zeroset
    mkdir -p "$to"
    "$zeroset" sample 'x^2 + y^2 + z^2 = 1' --size 8 -o "$to/ball.nrrd"
    "$zeroset" mesh 'x^2 + y^2 + z^2 = 1' --implicit -o "$to/ball.3mf"
    "$zeroset" share @klein >"$to/klein.txt"
    tests/fuzz/make_files.py "$to"
    find tests/engine/volume/files/packed tests/engine/volume/files/frames -type f \
        -exec cp -- {} "$to" \;
}
step_files() {
    local made folder=build/nightly/files
    sanitizer_options
    build_preset asan
    make_files "$folder"
    mapfile -t made < <(find "$folder" -type f)
    "$released/file_fuzz" --seconds "$fuzz_s" --seed "$RANDOM" build/nightly/tried "${made[@]}"
    build/asan/tests/file_fuzz --seconds "$fuzz_s" --seed "$RANDOM" build/nightly/tried "${made[@]}"
}
step_window() {
    sanitizer_options
    build_preset asan
    tests/end_to_end/monkey.py build/asan/zeroset --seconds "$fuzz_s"
}
step_tsan() {
    sanitizer_options
    build_preset tsan
    suite build/tsan -E "$timed"
}
