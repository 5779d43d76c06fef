/* Files without number and without end, under names of every kind. */
// ends: running
#include <stdio.h>
#include <unistd.h>

int main(void)
{
    char name[300];
    FILE *file;
    int i, k;

    for (i = 0;; i++) {
        for (k = 0; k < i % 250; k++)
            name[k] = "/.a\n\377~"[(i * 7 + k) % 6];
        name[k] = 0;
        file = fopen(name, i % 3 ? "w" : "a+");
        if (file == NULL)
            file = fopen("big", "a");
        if (file == NULL)
            continue;
        fseek(file, i % 2 ? 2147483647L - i : i * 1000L, SEEK_SET);
        for (k = 0; k < 40; k++)
            fputs(name, file);
        ftruncate(fileno(file), i * 100000L);
        if (i % 5)
            fclose(file);
        if (i % 7 == 0)
            rename(name, "other/name");
    }
}
