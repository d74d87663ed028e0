// exp and log by + - * / alone, so that they round alike on every machine.
#ifndef TSU_CHOOSE_PLAIN_H
#define TSU_CHOOSE_PLAIN_H

// e^x; x is held within +-80. Error: 2e-16 of the value for |x| < 1, 4e-15 at the ends.
double tsu_i_plain_exp(double x);
// ln x, x finite and above 1e-300. Error: 3e-16, or of the value.
double tsu_i_plain_log(double x);

#endif
