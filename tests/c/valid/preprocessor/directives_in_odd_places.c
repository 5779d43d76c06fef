/* Directives with spaces, comments and splices; null directives; conditionals inside expressions. */
#include <stdio.h>
#
    # /* one */ define /* two */ ONE /* three */ 1 /* four */
#   define  SPACED  ( ONE+1 )  
#def\
ine SPLICED 3
#define FUNCTION_LIKE(a)(a)
#define OBJECT_LIKE (4)
/**/ # define AFTER_COMMENT 5
#define UNUSED_BROKEN ) } ' is never used
#pragma whatever this says
# if ONE
# else
# error not reached
# endif

static int values[] = {
#if ONE
    1,
#endif
    2
#ifdef MISSING
    , 99
#else
    , 3
#endif
};

int main(void)
{
    int n = 10
#if 0
        * 100
#elif ONE
        + 5
#endif
        ;
    printf("%d %d %d %d %d\n", ONE, SPACED, SPLICED, FUNCTION_LIKE(6), OBJECT_LIKE);
    printf("%d %u %d\n", AFTER_COMMENT, (unsigned) (sizeof values / sizeof *values), n);
    return 0;
}
