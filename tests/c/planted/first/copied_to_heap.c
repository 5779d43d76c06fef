/* A struct with a hole is copied to the heap. */
#include <stdio.h>
#include <stdlib.h>
struct job { int id; double cost; };
static struct job *keep(struct job j)
{
    struct job *p = malloc(sizeof *p);
    *p = j;
    return p;
}
int main(void)
{
    struct job j, *kept;
    j.id = 4;
    PLANT(, j.cost = 1);
    kept = keep(j);
    printf("%d ", kept->id);
    printf("%s\n", kept->cost < 2 ? "cheap" : "dear"); // error: uninitialised read
    free(kept);
    return 0;
}
