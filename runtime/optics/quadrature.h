// Gauss-Legendre quadrature.
#ifndef TSU_OPTICS_QUADRATURE_H
#define TSU_OPTICS_QUADRATURE_H

#define TSU_I_QUADRATURE_PANEL 16 // nodes in a panel; exact for polynomials up to degree 31

// Node `index` of `panels * 16` on [a, b]; *weight gets its weight. Nodes come in no special order.
double tsu_i_quadrature_node(double a, double b, int panels, int index, double *weight);

// All nodes and weights of one rule of any size on [-1, 1], nodes falling from 1; exact up to
// rounding.
void tsu_i_quadrature_gauss(int count, double *nodes, double *weights);

#endif
