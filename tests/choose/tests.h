// The chooser's tests, one group a file.
#ifndef TSUYA_TESTS_CHOOSE_TESTS_H
#define TSUYA_TESTS_CHOOSE_TESTS_H

int input_tests(void);
int leaf_tests(void);
int rules_tests(void);
int steady_tests(void);

#endif
