// Groups of tests of the tier without GL.
#ifndef TSUYA_TESTS_API_TESTS_H
#define TSUYA_TESTS_API_TESTS_H

int schema_tests(void);
int input_tests(void);
int model_tests(void);
int null_tests(void);
int color_tests(void);
int head_tests(void);
int leaf_tests(void);
int leaf_scale_tests(void);
int leaf_scale_edge_tests(void);

#endif
