/* A ring of four in a struct, whose end is not wrapped. */
#include <stdio.h>
struct queue { int item[4]; int first, count; };
static int take(struct queue *q)
{
    int n = q->item[q->first]; // error: out of bounds
    q->first = PLANT(q->first + 1, (q->first + 1) % 4);
    q->count--;
    return n;
}
int main(void)
{
    struct queue q = {{1, 2, 3, 4}, 2, 4};
    int sum = 0;
    while (q.count > 0)
        sum += take(&q);
    printf("%d\n", sum);
    return 0;
}
