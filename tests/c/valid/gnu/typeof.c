/* typeof, __auto_type, statement expressions: macros that use them. */
#include <stdio.h>
#include <stddef.h>
#include <string.h>

#define max(a, b) ({ __auto_type a_ = (a); __auto_type b_ = (b); a_ > b_ ? a_ : b_; })
#define swap(a, b) do { typeof(a) t_ = (a); (a) = (b); (b) = t_; } while (0)
#define container_of(pointer, type, member) ({ \
    const typeof(((type *)0)->member) *inner_ = (pointer); \
    (type *)((char *)inner_ - offsetof(type, member)); })
#define length(array) (sizeof(array) / sizeof *(array))
#define each(item, array) \
    for (typeof(&(array)[0]) item = (array); item < (array) + length(array); item++)
#define once(expression) ({ static int done_; static typeof(expression) value_; \
    if (!done_) { done_ = 1; value_ = (expression); } value_; })

struct link { struct link *next; };
struct item { int number; struct link link; double weight; };
typedef int (*operation)(int, int);

static int calls;

static int add(int a, int b)
{
    calls++;
    return a + b;
}

typeof(int (*)(int, int)) pick(int which);

static typeof(add) *chosen = add;
static const typeof("text") words[] = {"one", "two", "333"};
extern typeof(calls) later;
static __typeof__(&words[0][0]) first = words[1];

operation pick(int which)
{
    return which ? add : (typeof(&add))0;
}

int main(void)
{
    struct item items[3] = {{1, {0}, 0.5}, {2, {0}, 1.5}, {3, {0}, 2.5}};
    struct link *head = NULL, *l;
    int i, n = 3, table[] = {4, 8, 15, 16, 23, 42}, sum = 0;
    double x = 1.5, y = 2;
    const char *s = "s", *t = "t";

    each(item, items) {
        item->link.next = head;
        head = &item->link;
    }
    for (l = head; l; l = l->next)
        printf("%d:%g ", container_of(l, struct item, link)->number,
               container_of(l, struct item, link)->weight);
    each(p, table)
        sum += *p;
    swap(x, y);
    swap(s, t);
    swap(items[0], items[2]);
    printf("%d %g %g %s%s %d\n", sum, x, y, s, t, items[0].number);
    printf("%d %g %lld\n", max(3, 4), max(2, max(1.5, 2.5f)), max(1LL << 40, n));
    for (i = 0; i < 3; i++)
        printf("%d ", once(add(i, 10)));
    printf("%d %d %s %s\n", calls, chosen(1, 2) + pick(1)(3, 4), first, words[2]);
    typeof(table) copy;
    memcpy(copy, table, sizeof copy);
    typeof(n) twice[n * 2];
    const typeof(x) half = x / 2;
    typeof(half) *pointer = &half;
    typeof(*items) one = {.number = ({ int k = 0; while (k * k < 50) k++; k; })};
    printf("%d %d %g %d\n", copy[5], (int)sizeof twice, *pointer, one.number);
    sum = ({ switch (n) { case 3: i = 30; break; default: i = 1; } i; }) + ({ if (n) n++; n; });
    printf("%d %d\n", sum, ({ struct item z = items[1]; z.number *= 9; z; }).number);
    return ({ goto out; 1; }) + 1;
out:
    printf("%d %d\n", later, (int)sizeof(typeof(char[7])));
    return 0;
}

int later = 77;
