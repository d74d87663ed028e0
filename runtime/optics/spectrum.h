// Spectra of reflectance under daylight to linear Rec. 709.
//
//   X = sum S(lambda) xbar(lambda) rho(lambda), Y and Z alike; S is illuminant D65, xbar, ybar,
//   zbar the CIE 1931 standard observer (2 degrees) rgb = P^-1 XYZ / P^-1 XYZ_white, channel by
//   channel; columns of P are the chromaticities of the primaries of Rec. 709, so that a perfect
//   white is (1, 1, 1) to rounding
//
// Spectra have values at 400, 410, .. 780 nm. The observer's 380 and 390 nm weigh the value at 400
// (as ASTM E308 does with missing ends). Channels of a narrow spectrum may be negative: light
// through a dark leaf is greener than the primaries.
//
// Error: of leaves' colours 5e-5 against sums at 5 nm; the white's x and y are 1e-4 off the ones
// printed for 5 nm, which divides out.
//
// Sources: CIE 15:2004, tables T.1 (D65) and T.4 (observer), every other row; ITU-R BT.709 (the
// primaries).
#ifndef TSU_OPTICS_SPECTRUM_H
#define TSU_OPTICS_SPECTRUM_H

enum { TSU_I_SPECTRUM_FIRST = 400, TSU_I_SPECTRUM_STEP = 10, TSU_I_SPECTRUM_POINTS = 39 };

// XYZ of a spectrum, Y of a perfect white 1.
void tsu_i_spectrum_xyz(const double value[TSU_I_SPECTRUM_POINTS], double xyz[3]);

// Linear Rec. 709 of a spectrum, white (1, 1, 1). The sum is linear in `value`.
void tsu_i_spectrum_rgb(const double value[TSU_I_SPECTRUM_POINTS], double rgb[3]);

#endif
