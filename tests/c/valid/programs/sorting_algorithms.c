/* Seven sorting algorithms give the same order. */
#include <stdio.h>
#include <string.h>

#define N 40

static void bubble(int *v, int n)
{
    int i, swapped, t;

    do
        for (swapped = 0, i = 1; i < n; i++)
            if (v[i - 1] > v[i])
                t = v[i], v[i] = v[i - 1], v[i - 1] = t, swapped = 1;
    while (swapped);
}

static void insertion(int *v, int n)
{
    int i, j, t;

    for (i = 1; i < n; v[j] = t, i++)
        for (t = v[i], j = i; j > 0 && v[j - 1] > t; j--)
            v[j] = v[j - 1];
}

static void selection(int *v, int n)
{
    int i, j, m, t;

    for (i = 0; i < n - 1; i++) {
        for (m = i, j = i + 1; j < n; j++)
            if (v[j] < v[m])
                m = j;
        t = v[i], v[i] = v[m], v[m] = t;
    }
}

static void shell(int *v, int n)
{
    int gap, i, j, t;

    for (gap = n / 2; gap > 0; gap /= 2)
        for (i = gap; i < n; i++)
            for (j = i - gap; j >= 0 && v[j] > v[j + gap]; j -= gap)
                t = v[j], v[j] = v[j + gap], v[j + gap] = t;
}

static void heap(int *v, int n)
{
    int start = n / 2, end = n, root, child, t;

    while (end > 1) {
        if (start > 0)
            start--;
        else
            end--, t = v[end], v[end] = v[0], v[0] = t;
        for (root = start; (child = 2 * root + 1) < end; root = child) {
            if (child + 1 < end && v[child] < v[child + 1])
                child++;
            if (v[root] >= v[child])
                break;
            t = v[root], v[root] = v[child], v[child] = t;
        }
    }
}

static void merge(int *v, int n)
{
    int w[N], half = n / 2, i = 0, j = half, k = 0;

    if (n < 2)
        return;
    merge(v, half);
    merge(v + half, n - half);
    while (k < n)
        w[k++] = j >= n || (i < half && v[i] <= v[j]) ? v[i++] : v[j++];
    memcpy(v, w, n * sizeof *v);
}

static void radix(int *v, int n)
{
    int w[N], shift, i, count[17];

    for (shift = 0; shift < 12; shift += 4) {
        memset(count, 0, sizeof count);
        for (i = 0; i < n; i++)
            count[(v[i] >> shift & 15) + 1]++;
        for (i = 0; i < 16; i++)
            count[i + 1] += count[i];
        for (i = 0; i < n; i++)
            w[count[v[i] >> shift & 15]++] = v[i];
        memcpy(v, w, n * sizeof *v);
    }
}

int main(void)
{
    static const struct { const char *name; void (*sort)(int *, int); } sorts[] = {
        { "bubble", bubble }, { "insertion", insertion }, { "selection", selection },
        { "shell", shell }, { "heap", heap }, { "merge", merge }, { "radix", radix },
    };
    unsigned seed = 12345;
    int input[N], sorted[N], v[N], i, k;

    for (i = 0; i < N; i++) {
        seed = seed * 1103515245u + 12345u;
        input[i] = seed >> 16 & 0xFFF;
    }
    memcpy(sorted, input, sizeof input);
    insertion(sorted, N);
    for (i = 0; i < N; i++)
        printf("%d ", sorted[i]);
    printf("\n");
    for (k = 0; k < 7; k++) {
        memcpy(v, input, sizeof v);
        sorts[k].sort(v, N);
        printf("%s %d\n", sorts[k].name, memcmp(v, sorted, sizeof v) == 0);
    }
    return 0;
}
