/* A flag of a new struct is tested. */
#include <stdio.h>
#include <stdlib.h>
struct task { int id; int done; struct task *next; };
static struct task *list;
static void add(int id)
{
    struct task *t = malloc(sizeof *t);
    t->id = id;
    PLANT(, t->done = 0);
    t->next = list;
    list = t;
}
int main(void)
{
    add(1);
    while (list && !list->done) { // error: uninitialised read
        struct task *t = list;
        list = t->next;
        free(t);
    }
    return 0;
}
