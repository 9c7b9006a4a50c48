// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <iostream>
#include <string>

#include <benchmark/benchmark.h>

#include "figures.hpp"

/// Without arguments: the table of figures. With some: Google Benchmark as it comes.
int main(int argc, char** argv) {
  if (argc == 1) {
    std::string name = "selion_bench";
    std::string often = "--benchmark_repetitions=9";
    std::string briefly = "--benchmark_min_time=0.1";
    std::array<char*, 4> arguments{name.data(), often.data(), briefly.data(), nullptr};
    int count = 3;
    benchmark::Initialize(&count, arguments.data());
    selion::print_figures(std::cout);
  } else {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
  }
  benchmark::Shutdown();
}
