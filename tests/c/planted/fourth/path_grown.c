/* A path that grows; its first point is kept by a pointer. */
#include <stdio.h>
#include <stdlib.h>

struct point {
    int x, y;
};

struct path {
    struct point *points, *first;
    int count;
};

static void append(struct path *path, int x, int y)
{
    path->points = realloc(path->points, (path->count + 1) * sizeof *path->points);
    path->points[path->count].x = x;
    path->points[path->count].y = y;
    path->count++;
    if (PLANT(path->count == 1, 1))
        path->first = path->points;
}

int main(void)
{
    struct path path = {NULL, NULL, 0};

    for (int i = 0; i < 3; i++)
        append(&path, i, 2 * i);
    printf("%d\n", path.first->y); // error: use after free
    free(path.points);
    return 0;
}
