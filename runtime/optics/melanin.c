#include "optics/melanin.h"

void tsu_i_melanin_absorption(double eumelanin, double pheomelanin, double sigma_a[3])
{
    static const double eu[3] = {0.419, 0.697, 1.37}, pheo[3] = {0.187, 0.4, 1.05};
    for (int k = 0; k < 3; k++)
        sigma_a[k] = eumelanin * eu[k] + pheomelanin * pheo[k];
}
