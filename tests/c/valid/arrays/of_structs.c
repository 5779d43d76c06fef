/* Arrays of structs: access, copying, sorting, passing. */
#include <stdio.h>

struct reading { char name[8]; int value; double weight; };

static struct reading log_[5] = {
    { "front", 30, 0.5 }, { "left", 12, 1.0 }, { "back", 99, 0.25 }, { "right", 5, 2.0 },
};

static void sort(struct reading *r, int n)
{
    int i, j;

    for (i = 1; i < n; i++) {
        struct reading moved = r[i];
        for (j = i; j > 0 && r[j - 1].value > moved.value; j--)
            r[j] = r[j - 1];
        r[j] = moved;
    }
}

static double weighted(const struct reading *r, const struct reading *end)
{
    double sum = 0;

    for (; r < end; r++)
        sum += r->value * r->weight;
    return sum;
}

int main(void)
{
    struct reading copy[5], *p;
    int i;

    for (i = 0; i < 5; i++)
        copy[i] = log_[i];
    sort(copy, 4);
    for (p = copy; p < copy + 4; p++)
        printf("%s %d %g\n", p->name, p->value, p->weight);
    printf("%g %g\n", weighted(log_, log_ + 4), weighted(copy, copy + 4));
    printf("[%s] %d\n", log_[4].name, log_[4].value);
    copy[2].name[0] = 'X';
    (copy + 1)->value++;
    printf("%s %d %s\n", copy[2].name, copy[1].value, log_[0].name);
    printf("%d\n", (int) (&copy[3] - copy));
    printf("%c\n", copy[0].name[1]);
    return 0;
}
