// One function of a model on many rows: by the reference, by the tables in C, or by the GPU.
#ifndef TSUYA_DEMO_COMMAND_EVALUATE_H
#define TSUYA_DEMO_COMMAND_EVALUATE_H

#include "function.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tsuya::command {

// Rows of inputs in units of the API, inside their ranges: in[row * inputs + input].
struct Question {
    Function function;
    std::size_t rows = 0;
    std::vector<double> in;
};

// Why there are no results. `row` is the row to blame, or no_row.
struct Failure {
    static constexpr std::size_t no_row = std::size_t(-1);
    std::size_t row = no_row;
    std::string text;
};

// out[row * outputs + output], in units of the API. False on failure; `out` is then of no use.
//
// Reference: double precision, rows spread over all cores.
bool evaluate_reference(const Question &question, std::vector<double> &out, Failure &failure);

// Tables and GPU: rows are grouped by their material inputs; every different combination becomes a
// material of a set, baked on all cores. Materials are taken in batches that fit one texture of
// 2048 x 2048 texels, so that memory stays bounded; a batch costs a bake for every table in it.
//
// tables  tsu_set_evaluate
// gpu     the shader text that `tsuya glsl` prints, with the probe of the function; the results are
//         floats. Errors: no OpenGL 3.3 on this machine.
enum class Where { tables, gpu };
bool evaluate_tables(const Question &question, Where where, std::vector<double> &out,
                     Failure &failure);

} // namespace tsuya::command

#endif
