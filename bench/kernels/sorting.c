/* qsort with a comparator through a function pointer, and a quicksort of our own. */
#include <stdio.h>
#include <stdlib.h>

#define COUNT 60000

static int values[COUNT], copy[COUNT];

static int ascending(const void *a, const void *b)
{
    int x = *(const int *) a, y = *(const int *) b;

    return (x > y) - (x < y);
}

static void quicksort(int *v, int low, int high)
{
    while (low < high) {
        int pivot = v[(low + high) / 2], i = low, j = high, t;

        while (i <= j) {
            while (v[i] < pivot)
                i++;
            while (v[j] > pivot)
                j--;
            if (i <= j) {
                t = v[i];
                v[i++] = v[j];
                v[j--] = t;
            }
        }
        if (j - low < high - i) {
            quicksort(v, low, j);
            low = i;
        } else {
            quicksort(v, i, high);
            high = j;
        }
    }
}

int main(void)
{
    unsigned seed = 11, sum = 0;
    int i, round;

    for (round = 0; round < 6; round++) {
        for (i = 0; i < COUNT; i++) {
            seed = seed * 1664525u + 1013904223u;
            values[i] = copy[i] = (int) (seed >> 4);
        }
        qsort(values, COUNT, sizeof values[0], ascending);
        quicksort(copy, 0, COUNT - 1);
        for (i = 0; i < COUNT; i++) {
            if (values[i] != copy[i])
                return 1;
            sum = sum * 5 + values[i];
        }
    }
    printf("sorting %u\n", sum);
    return 0;
}
