/* Comments act as spaces, do not nest, and do not start in strings. */
#include <stdio.h>

#define EMPTY/* nothing */
#define GLUE(a,b)a/**/b

int main(void)
{
    int a = 10, b = 2, *p = &b;
    int quotient = a/ *p;
    int same = a//**/b
        - 1;
    printf("%d %d\n", quotient, same);
    printf("/* not a comment */ // nor this\n");
    printf("%d\n", a /* one */ + /* two */ b // three
           + 1);
    printf("%c%c\n", '"', '\'' /* ' */);
    printf("%d\n", 1 /* " */ + 1 /* " */);
    /* / * // ** /* */
    printf("%d%s\n", GLUE(-, 2), "" EMPTY);
    /**/
    //
    return 0; /***/
}
