// Hair pigments.
#ifndef TSU_OPTICS_MELANIN_H
#define TSU_OPTICS_MELANIN_H

// sigma_a per fibre radius of concentrations of eumelanin and pheomelanin, linear Rec. 709.
// Source: d'Eon et al. 2011, section 6.1.
void tsu_i_melanin_absorption(double eumelanin, double pheomelanin, double sigma_a[3]);

#endif
