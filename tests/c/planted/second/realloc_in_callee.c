/* The callee makes the buffer longer, and the caller goes on with its own copy. */
#include <stdio.h>
#include <stdlib.h>
struct text { char *at; int size; };
static void grow(struct text *t) { t->at = realloc(t->at, t->size *= 2); }
int main(void)
{
    struct text t = {malloc(8), 8};
    char *first = t.at;
    first[0] = 'o';
    first[1] = 0;
    grow(&t);
    puts(PLANT(first, t.at)); // error: use after free
    free(t.at);
    return 0;
}
