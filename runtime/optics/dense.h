// Dense matrices, row-major, n x n unless stated.
#ifndef TSU_OPTICS_DENSE_H
#define TSU_OPTICS_DENSE_H

#include <stddef.h>

// c += a b. c overlaps neither a nor b.
void tsu_i_dense_add(int n, const double *a, const double *b, double *c);
// c += the sum over k of weights[k] times row k of b; rows are `pitch` apart, `columns` of each.
void tsu_i_dense_rows(int rows, const double *weights, const double *b, size_t pitch, int columns,
                      double *c);
// x = a^-1 x for x of n x columns; destroys a. No pivots: for matrices 1 - M with norm(M) < 1,
// whose diagonal dominates.
void tsu_i_dense_solve(int n, double *a, int columns, double *x);

#endif
