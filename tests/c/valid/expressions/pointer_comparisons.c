/* Pointers compared and subtracted within an array, with null, and as conditions. */
#include <stddef.h>
#include <stdio.h>

struct item { short key; double value; };

int main(void)
{
    int a[10];
    struct item items[4], *first = items, *last = &items[3];
    char *text = "hello", *end = text;
    void *any = a, *none = 0;
    int (*f)(const char *) = puts;

    printf("%d %d %d\n", &a[3] < &a[7], &a[10] > a, &a[5] == a + 5);
    printf("%d %d\n", (int) (&a[10] - a), (int) (a - &a[4]));
    printf("%d %d\n", (int) (last - first), (int) ((char *) last - (char *) first));
    while (*end)
        end++;
    printf("%d\n", (int) (end - text));
    printf("%d %d %d\n", any == a, none == NULL, !none);
    printf("%d %d\n", (int *) any + 1 == &a[1], any != none && any);
    printf("%d %d\n", f == puts, f != NULL);
    printf("%d\n", (void *) first == (void *) &first->key);
    printf("%d\n", &items[1].value > &items[0].value);
    printf("%d %d\n", (int) sizeof(end - text), (int) sizeof(ptrdiff_t));
    if (!f || !text)
        return 1;
    for (struct item *each = items + 4; each-- > items;)
        each->key = (short) (each - items);
    printf("%d %d\n", items[0].key, last->key);
    return 0;
}
