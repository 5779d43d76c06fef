/* Predefined macros (C17 6.10.8) and their values. */
#include <stdio.h>
#include <string.h>

#define LINE_HERE __LINE__
static const char *function(void) { return __func__; }

int main(void)
{
    const char *file = strrchr(__FILE__, '/') ? strrchr(__FILE__, '/') + 1 : __FILE__;

    printf("%s %d %d\n", file, __LINE__, LINE_HERE);
    printf("%d %ld %d\n", __STDC__, __STDC_VERSION__, __STDC_HOSTED__);
    printf("%s %s\n", function(), __FUNCTION__);
    printf("%u %u\n", (unsigned) strlen(__DATE__), (unsigned) strlen(__TIME__));
#line 1000 "other.c"
    printf("%s %d\n", __FILE__, __LINE__);
#line 7
    printf("%s %d %d\n", __FILE__, LINE_HERE,
           __LINE__);
#ifdef __cplusplus
    puts("C++");
#endif
#if defined __STDC__ && !defined __STDC_IEC_559_COMPLEX_X__
    puts("C");
#endif
#ifdef linux_is_not_promised
    puts("?");
#endif
    return 0;
}
