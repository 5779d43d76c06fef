/* The best of a list that may be empty. */
#include <stdio.h>
struct best { int index; double score; };
static struct best search(const double *score, int n)
{
    struct best b;
    int i;
    b.score = -1;
    PLANT(, b.index = -1);
    for (i = 0; i < n; i++)
        if (score[i] > b.score) {
            b.index = i;
            b.score = score[i];
        }
    return b;
}
int main(void)
{
    double s[1] = {1};
    struct best b = search(s, 0);
    printf("%d\n", b.index); // error: uninitialised read
    return 0;
}
