/* Text: words counted in a hash table of strings, reversed, compared, joined. */
#include <stdio.h>
#include <string.h>

#define BUCKETS 4096
#define WORDS 12000

static char names[WORDS][16];
static int counts[WORDS], buckets[BUCKETS], next[WORDS], used;
static char text[60000];

static unsigned hash(const char *s)
{
    unsigned h = 2166136261u;

    while (*s)
        h = (h ^ (unsigned char) *s++) * 16777619u;
    return h;
}

static int find(const char *word)
{
    unsigned h = hash(word) % BUCKETS;
    int i;

    for (i = buckets[h]; i; i = next[i])
        if (strcmp(names[i], word) == 0)
            return i;
    i = ++used;
    strcpy(names[i], word);
    next[i] = buckets[h];
    buckets[h] = i;
    return i;
}

static void reverse(char *s)
{
    char *end = s + strlen(s) - 1, t;

    for (; s < end; s++, end--) {
        t = *s;
        *s = *end;
        *end = t;
    }
}

int main(void)
{
    unsigned seed = 7, sum = 0;
    char word[16], *p, *to;
    int i, j, round, n;

    for (p = text; p < text + sizeof text - 20;) {
        seed = seed * 1664525u + 1013904223u;
        n = 2 + (seed >> 28) % 7;
        for (j = 0; j < n; j++) {
            seed = seed * 1664525u + 1013904223u;
            *p++ = "aeinorst"[seed >> 29];
            if (j > 1 && (seed >> 20 & 1))
                break;
        }
        *p++ = ' ';
    }
    for (round = 0; round < 60; round++)
        for (p = text; *p;) {
            for (to = word; *p != ' ';)
                *to++ = *p++;
            *to = 0;
            p++;
            if (round & 1)
                reverse(word);
            i = find(word);
            if (i >= WORDS - 1)
                return 1;
            counts[i]++;
        }
    for (i = 1; i <= used; i++)
        sum = sum * 31 + counts[i] + names[i][0];
    printf("strings %d %u\n", used, sum);
    return 0;
}
