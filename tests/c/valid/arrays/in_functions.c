/* Array parameters: binary search, rotation, histogram, prefix sums, merge. */
#include <stdio.h>

static int search(const int v[], int n, int key)
{
    int low = 0, high = n;

    while (low < high) {
        int middle = low + (high - low) / 2;
        if (v[middle] < key)
            low = middle + 1;
        else
            high = middle;
    }
    return low < n && v[low] == key ? low : -1 - low;
}

static void reverse(int *v, int n)
{
    int i, t;

    for (i = 0; i < n / 2; i++)
        t = v[i], v[i] = v[n - 1 - i], v[n - 1 - i] = t;
}

static void rotate_left(int v[], int n, int by)
{
    reverse(v, by);
    reverse(v + by, n - by);
    reverse(v, n);
}

static int merge(int *out, const int *a, int na, const int *b, int nb)
{
    int *start = out;

    while (na && nb)
        *out++ = *a <= *b ? (na--, *a++) : (nb--, *b++);
    while (na--)
        *out++ = *a++;
    while (nb--)
        *out++ = *b++;
    return out - start;
}

int main(void)
{
    int v[] = { 2, 3, 5, 7, 11, 13, 17 }, w[] = { 1, 4, 6, 8, 20 }, out[12], i, n;
    int histogram[5] = { 0 };
    const char *text = "abracadabra";

    printf("%d %d %d %d\n", search(v, 7, 7), search(v, 7, 2), search(v, 7, 17), search(v, 7, 6));
    n = merge(out, v, 7, w, 5);
    for (i = 0; i < n; i++)
        printf("%d ", out[i]);
    printf("\n");
    rotate_left(out, n, 4);
    for (i = 0; i < n; i++)
        printf("%d ", out[i]);
    printf("\n");
    for (i = 1; i < n; i++)
        out[i] += out[i - 1];
    printf("%d\n", out[n - 1]);
    for (; *text; text++)
        if (*text - 'a' < 5)
            histogram[*text - 'a']++;
    for (i = 0; i < 5; i++)
        printf("%c%d ", 'a' + i, histogram[i]);
    printf("\n");
    return 0;
}
