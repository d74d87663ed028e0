#ifndef TSUYA_TESTS_HAIR_SHADOW_TESTS_H
#define TSUYA_TESTS_HAIR_SHADOW_TESTS_H

int map_tests(void);
int plan_tests(void);

#endif
