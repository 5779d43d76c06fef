/* What GNU and C23 preprocessors know, in odd places. */
#include <stdio.h>
#define LOG(fmt, args...) printf(fmt , ##args)
#define LOG2(fmt, ...) printf(fmt __VA_OPT__(,) __VA_ARGS__)
#define STR(x...) #x
#define OPT(x, ...) "[" #__VA_OPT__(x __VA_ARGS__) "]"
#define COUNT __COUNTER__
_Pragma("once") int odd = 3;
#ident "version 1"
#line 100 "renamed.c"
int line = __LINE__; const char *file = __FILE__;
#line 13
int dollar$name = 4;
int gr\u00f6\u00dfe = 5;
int größe2 = 6;
%:define DIGRAPH 7
int digraph<:2:> = <% DIGRAPH, 8 %>;
int spl\
iced = 9;
#de\
fine SPLICED 10
/* com\
ment */ // line \
 continued comment
#if __has_include(<stdio.h>) && !__has_include("nothere.h") && defined __GNUC__ || defined(__CRS__)
int has = 11;
#endif
int main(void)
{
    LOG("a\n"); LOG("%d\n", 1); LOG2("b\n"); LOG2("%d %d\n", 1, 2);
    puts(STR(a, b)); puts(OPT(1)); puts(OPT(1, 2));
    printf("%d %d %d\n", COUNT, COUNT, odd);
    printf("%d %s %d %d %d\n", line, file, dollar$name, größe, gr\u00f6\u00dfe2);
    printf("%d %d %d %d %d\n", digraph[1], spliced, SPLICED, has, __LINE__);
    printf("%s %ld %d\n", __func__, __STDC_VERSION__, __STDC__);
    return 0;
}
