/* A growing string, words counted with a hash table of linked entries, sorted and justified. */
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct { char *text; size_t length, room; } String;

static void reserve(String *s, size_t more)
{
    if (s->length + more + 1 <= s->room)
        return;
    while (s->length + more + 1 > s->room)
        s->room = s->room ? s->room * 2 : 8;
    s->text = realloc(s->text, s->room);
}

static String *append(String *s, const char *text)
{
    size_t n = strlen(text);
    reserve(s, n);
    memcpy(s->text + s->length, text, n + 1);
    s->length += n;
    return s;
}

static String *format(String *s, const char *form, ...)
{
    va_list list, again;
    va_start(list, form);
    va_copy(again, list);
    int n = vsnprintf(NULL, 0, form, list);
    reserve(s, (size_t) n);
    vsnprintf(s->text + s->length, (size_t) n + 1, form, again);
    s->length += (size_t) n;
    va_end(again);
    va_end(list);
    return s;
}

#define BUCKETS 16
struct entry { struct entry *next; int count; char word[]; };
static struct entry *table[BUCKETS];

static struct entry *lookup(const char *word)
{
    unsigned hash = 5381;
    for (const char *p = word; *p; p++)
        hash = hash * 33 ^ (unsigned char) *p;
    struct entry **place = &table[hash % BUCKETS];
    for (; *place; place = &(*place)->next)
        if (!strcmp((*place)->word, word))
            return *place;
    *place = calloc(1, sizeof **place + strlen(word) + 1);
    strcpy((*place)->word, word);
    return *place;
}

static int most_first(const void *a, const void *b)
{
    const struct entry *x = *(struct entry *const *) a, *y = *(struct entry *const *) b;
    return x->count != y->count ? y->count - x->count : strcmp(x->word, y->word);
}

int main(void)
{
    static const char text[] =
        "The robot turns, and the robot moves; the wall is near, the wall is far. And the robot stops!";
    char word[20];
    int n = 0, count = 0;
    struct entry *all[32];
    String out = { 0 };

    for (const char *p = text;; p++)
        if (isalpha((unsigned char) *p))
            word[n++] = (char) tolower((unsigned char) *p);
        else {
            word[n] = '\0';
            if (n)
                lookup(word)->count++;
            n = 0;
            if (!*p)
                break;
        }
    for (int i = 0; i < BUCKETS; i++)
        for (struct entry *e = table[i]; e; e = e->next)
            all[count++] = e;
    qsort(all, (size_t) count, sizeof *all, most_first);
    for (int i = 0; i < count; i++)
        format(append(&out, i ? ", " : ""), "%s x%d", all[i]->word, all[i]->count);
    printf("%s\n%u of %u\n", out.text, (unsigned) out.length, (unsigned) out.room);
    out.length = 0;
    append(append(append(&out, "<"), ""), ">");
    printf("%s\n", out.text);
    for (int i = 0; i < count; i++)
        free(all[i]);
    free(out.text);
    return 0;
}
