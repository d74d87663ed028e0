#include "optics/dense.h"

// Four rows of b a pass: each row of c is read and written a quarter as often.
static void row_add(int columns, const double *restrict weights, const double *restrict b,
                    size_t pitch, double *restrict c)
{
    const double w0 = weights[0], w1 = weights[1], w2 = weights[2], w3 = weights[3];
    const double *restrict b1 = b + pitch, *restrict b2 = b1 + pitch, *restrict b3 = b2 + pitch;
    for (int j = 0; j < columns; j++)
        c[j] += (w0 * b[j] + w1 * b1[j]) + (w2 * b2[j] + w3 * b3[j]);
}

static void row_add_one(int columns, double weight, const double *restrict b, double *restrict c)
{
    for (int j = 0; j < columns; j++)
        c[j] += weight * b[j];
}

void tsu_i_dense_rows(int rows, const double *weights, const double *b, size_t pitch, int columns,
                      double *c)
{
    int k = 0;
    for (; k + 4 <= rows; k += 4)
        row_add(columns, weights + k, b + (size_t)k * pitch, pitch, c);
    for (; k < rows; k++)
        row_add_one(columns, weights[k], b + (size_t)k * pitch, c);
}

void tsu_i_dense_add(int n, const double *a, const double *b, double *c)
{
    // A band of b's rows stays in the cache for all rows of c.
    enum { BAND = 32 };
    const size_t pitch = (size_t)n;
    for (int band = 0; band < n; band += BAND) {
        const int end = band + BAND < n ? band + BAND : n;
        for (int i = 0; i < n; i++) {
            double *out = c + (size_t)i * pitch;
            tsu_i_dense_rows(end - band, a + (size_t)i * pitch + (size_t)band,
                             b + (size_t)band * pitch, pitch, n, out);
        }
    }
}

void tsu_i_dense_solve(int n, double *a, int columns, double *x)
{
    const size_t pitch = (size_t)n, wide = (size_t)columns;
    for (int k = 0; k < n; k++) {
        const double *pivot = a + (size_t)k * pitch;
        for (int i = k + 1; i < n; i++) {
            double *row = a + (size_t)i * pitch;
            const double factor = row[k] / pivot[k];
            row_add_one(n - k - 1, -factor, pivot + k + 1, row + k + 1);
            row_add_one(columns, -factor, x + (size_t)k * wide, x + (size_t)i * wide);
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        double *row = x + (size_t)k * wide;
        for (int i = k + 1; i < n; i++)
            row_add_one(columns, -a[(size_t)k * pitch + (size_t)i], x + (size_t)i * wide, row);
        const double scale = 1.0 / a[(size_t)k * pitch + (size_t)k];
        for (int j = 0; j < columns; j++)
            row[j] *= scale;
    }
}
