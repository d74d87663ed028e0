#include "optics/strand_named.h"

#include "optics/angle.h"

#define DEGREES(x) ((x) * (TSU_I_PI / 180.0))

struct tsu_i_strand_columns tsu_i_strand_named(const double columns[5], int name)
{
    enum { R_TT_TRT = 3, ALL = TSU_I_LOBES };
    static const struct {
        double alpha, beta, beta_az;
        int kind, lobes;
    } named[] = {
        {-7.5, 7.5, 10.0, TSU_I_STRAND_GAUSSIAN, ALL},
        {-7.5, 7.5, 10.0, TSU_I_STRAND_DIFFERENCE, R_TT_TRT},
        {-7.5, 7.5, 10.0, TSU_I_STRAND_DIFFERENCE, ALL},
        {-10.0, 10.0, 20.0, TSU_I_STRAND_DIFFERENCE, R_TT_TRT},
        {-5.0, 5.0, 10.0, TSU_I_STRAND_DIFFERENCE, R_TT_TRT},
        {-15.0, 15.0, 10.0, TSU_I_STRAND_DIFFERENCE, R_TT_TRT},
        {-7.5, 7.5, 10.0, TSU_I_STRAND_LITERAL, R_TT_TRT},
    };
    if (name < 1 || name > (int)(sizeof named / sizeof *named))
        return (struct tsu_i_strand_columns){columns[0], columns[1],        columns[2], columns[3],
                                             columns[4], TSU_I_STRAND_DEON, ALL};
    const int i = name - 1;
    return (struct tsu_i_strand_columns){
        1.55, DEGREES(named[i].alpha), DEGREES(named[i].beta), DEGREES(named[i].beta_az),
        0.0,  named[i].kind,           named[i].lobes};
}
