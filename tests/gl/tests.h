// The groups of gl_test.
#ifndef TSUYA_TESTS_GL_TESTS_H
#define TSUYA_TESTS_GL_TESTS_H

// Return the number of failed tests.
int create_tests(void);
int sync_tests(void);
int sync_edge_tests(void);
int bind_tests(void);
int check_tests(void);
int hostile_tests(void);

#endif
