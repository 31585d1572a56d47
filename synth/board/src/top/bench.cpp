// Ticks a board and writes its pins: after both edges of each clock, or before the rising one.
#include "Vboard_bench.h"
#include "verilated.h"
#include <cstdio>
#include <cstdlib>

double sc_time_stamp() { return 0; }

int main(int, char** arguments) {
    const unsigned long long clocks = std::strtoull(arguments[1], nullptr, 10);
    const bool both = arguments[2][0] == '2';
    std::FILE* file = std::fopen(arguments[3], "wb");
    if (!file) return 1;
    Vboard_bench board;
    bool written = true;
    auto write = [&] { written &= std::fwrite(&board.pins, 4, 1, file) == 1; };
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
