/* Word wrap and justification, table layout, word counts. */
#include <stdio.h>
#include <string.h>

static const char *text =
    "The Nomad Scout is an integrated mobile robot system with ultrasonic, tactile and odometry "
    "sensing. It uses a special multiprocessor low-level control system that controls the sensing, "
    "motion, and communications.";

static void justify(const char **words, int count, int width, int last)
{
    int i, gap, letters = 0, spaces;

    for (i = 0; i < count; i++)
        letters += strcspn(words[i], " ");
    spaces = last ? count - 1 : width - letters;
    for (i = 0; i < count; i++) {
        printf("%.*s", (int) strcspn(words[i], " "), words[i]);
        if (i < count - 1) {
            gap = spaces / (count - 1 - i);
            printf("%*s", gap, "");
            spaces -= gap;
        }
    }
    printf("|\n");
}

static void wrap(const char *p, int width)
{
    const char *words[40];
    int count = 0, length = 0;

    while (*p) {
        int n = strcspn(p, " ");
        if (count && length + 1 + n > width) {
            justify(words, count, width, 0);
            count = length = 0;
        }
        length += n + (count > 0);
        words[count++] = p;
        p += n;
        p += strspn(p, " ");
    }
    justify(words, count, width, 1);
}

struct row { const char *name; int count; double share; };

static void table(const struct row *rows, int n)
{
    int i, widest = 0;

    for (i = 0; i < n; i++)
        if ((int) strlen(rows[i].name) > widest)
            widest = strlen(rows[i].name);
    for (i = 0; i < n; i++)
        printf("%-*s|%5d|%6.1f%%|\n", widest, rows[i].name, rows[i].count, rows[i].share * 100);
}

int main(void)
{
    struct row rows[] = { { "forward", 120, 0.6 }, { "turn", 75, 0.375 }, { "back", 5, 0.025 } };
    int counts[12] = { 0 }, i;
    const char *p = text;

    wrap(text, 36);
    wrap(text, 60);
    table(rows, 3);
    while (*p) {
        int n = strcspn(p, " ,.");
        counts[n < 11 ? n : 11]++;
        p += n;
        p += strspn(p, " ,.");
    }
    for (i = 1; i < 12; i++)
        printf("%d%s", counts[i], i == 11 ? "\n" : " ");
    return 0;
}
