/* A list that points to itself is lost; one that is held in its middle is not. */
#include <stdlib.h>
struct link { struct link *next; int pad[6]; };
static int *held;
int main(void)
{
    struct link *a = malloc(sizeof *a), *b = malloc(sizeof *b); // leak: 2
    struct link *c = malloc(sizeof *c);
    a->next = b;
    b->next = a;
    held = &c->pad[3];
    PLANT(, (free(a), free(b)));
    a = b = c = 0;
    return 0;
}
