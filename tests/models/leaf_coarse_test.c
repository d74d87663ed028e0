// What leaf_coarse states about its errors, measured again as leaf_body's.
//
//   leaf_coarse_test      a sample, no measured error may exceed the stated one
//   leaf_coarse_test N    N times as many leaves; with TSUYA_LONG set, 12
#include "leaf_errors.h"

#include <tsuya/models/leaf_coarse.h>

#include <stdlib.h>

int main(int argc, char **argv)
{
    const int scale = argc > 1 ? atoi(argv[1]) : getenv("TSUYA_LONG") ? 12 : 1;
    const tsu_model *const model = tsu_leaf_coarse();
    struct sweep sweep;
    struct worst worst = {0};
    sweep_open(&sweep, 20121116);
    leaf_sweep(&sweep, model, 16 * scale, &worst);
    sweep_close(&sweep);
    int fine = leaf_report(model, "reflected", worst.reflected, -1);
    fine &= leaf_report(model, "transmitted", worst.transmitted, -1);
    fine &= leaf_report(model, "dim", worst.dim, -1);
    fine &= leaf_report(model, "power", worst.power, -1);
    return fine ? 0 : 1;
}
