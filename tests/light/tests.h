// Groups of light_tests; each returns the number of failures.
#ifndef TESTS_LIGHT_TESTS_H
#define TESTS_LIGHT_TESTS_H

int light_tests(void);
int environment_tests(void);

#endif
