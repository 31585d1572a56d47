// Ticks a board and writes the lowest bytes of its pins: after both edges of each clock, or before the rising one.
#include "Vboard_bench.h"
#include "verilated.h"
#include <cstdio>
#include <cstdlib>

double sc_time_stamp() { return 0; }

int main(int, char** arguments) {
    const unsigned long long clocks = std::strtoull(arguments[1], nullptr, 10);
    const bool both = arguments[2][0] == '2';
    const std::size_t bytes = std::strtoull(arguments[3], nullptr, 10);
    std::FILE* file = std::fopen(arguments[4], "wb");
    if (!file) return 1;
    Vboard_bench board;
    bool written = true;
    auto write = [&] { written &= std::fwrite(&board.pins, bytes, 1, file) == 1; };
    for (unsigned long long clock = 0; clock < clocks; clock++) {
        board.clock = 1;
        board.eval();
        if (both) write();
        board.clock = 0;
        board.eval();
        write();
    }
    return written && std::fclose(file) == 0 ? 0 : 1;
}
