/* Words are counted by length in a table of a struct, in front of its total. */
#include <stdio.h>
#include <string.h>

struct summary {
    int by_length[6];
    int total;
};

static void add(struct summary *summary, const char *word)
{
    int length = strlen(word);

    summary->by_length[length PLANT(,- 1)]++; // error: out of bounds
    summary->total++;
}

int main(void)
{
    static const char *const words[] = {"go", "left", "stop", "slower"};
    struct summary summary = {{0}, 0};

    for (int i = 0; i < 4; i++)
        add(&summary, words[i]);
    printf("%d %d\n", summary.by_length[3], summary.total);
    return 0;
}
