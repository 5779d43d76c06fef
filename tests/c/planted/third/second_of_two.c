/* A frame is read with a pointer that was set to one of two blocks. */
#include <stdio.h>
#include <stdlib.h>
static int *frame;
static int wider(int *p) { return p >= frame; } // warning: pointers to different objects
int main(void)
{
    int *lines = malloc(100 * sizeof *lines), *columns = malloc(100 * sizeof *columns);
    frame = PLANT(columns, lines);
    printf("%d\n", wider(lines + 30) >= 0);
    free(lines);
    free(columns);
    return 0;
}
