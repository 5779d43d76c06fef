/* Counters that nobody set, counted up and never looked at. */
#include <stdio.h>
#include <stdlib.h>

struct counts { int hits, misses; double mean; char kinds[4]; long long total; };

static void count(struct counts *c, int hit)
{
    c->misses += !hit;
    c->total = c->total * 2 + hit;
    c->mean = (c->mean + hit) / 2;
    c->kinds[hit]++;
    c->kinds[2] = c->kinds[0] ^ c->kinds[1];
}

int main(void)
{
    struct counts *c = malloc(sizeof *c), local;
    int i, sums[8];

    c->hits = 0;
    for (i = 0; i < 10; i++) {
        count(c, i % 3 == 0);
        c->hits += i % 3 == 0;
    }
    local.misses++;
    local.hits = local.misses - c->hits;
    local.hits = 3;
    for (i = 0; i < 8; i++)
        sums[i] += i;
    sums[3] = 2;
    sums[4] = sums[3] + 1;
    printf("%d %d %d\n", c->hits, local.hits, sums[4]);
    free(c);
    return 0;
}
