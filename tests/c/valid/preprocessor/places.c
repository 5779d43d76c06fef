/* __LINE__, __FILE__, #line, assert-like macros, comments in odd places. */
#include <stdio.h>
#include <string.h>

#define HERE printf("%d\n", __LINE__)
#define CHECK(c) ((c) ? (void) 0 : (void) printf("line %d: %s failed\n", __LINE__, #c))
#define TWO(a, b) a \
    + b

int/*comment*/main(void)
{
    const char *file = __FILE__;

    HERE;
    CHECK(1 + 1 == 3);
    CHECK(/* inside */ 2 > 1);
    printf("%d\n", TWO(1,
                       __LINE__ > 0));
    printf("%d\n", strcmp(file + strlen(file) - 8, "places.c")); // to the end \
       of the line, continued
    printf("/* not a comment */ // neither\n");
    printf("%d\n", 7 /* a */ / /* b */ 2);
#line 1000
    HERE;
#line 2000 "other.c"
    printf("%s %d\n", __FILE__, __LINE__);
    HERE;
    return 0;
}
