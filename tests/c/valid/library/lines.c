/* Lines of any length, pieces of files, the environment, and the end of a program. */
#define _GNU_SOURCE
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int compare(const void *left, const void *right)
{
    return *(const int *)left - *(const int *)right;
}

static int compare_by(const void *left, const void *right, void *sign)
{
    return *(int *)sign * (*(const int *)left - *(const int *)right);
}

static void at_end(int status, void *argument)
{
    printf("%s with %d\n", (const char *)argument, status);
}

int main(void)
{
    FILE *file = tmpfile();
    char *line = NULL, name[] = "/tmp/crs-XXXXXX";
    size_t size = 0, count = 4;
    int numbers[8] = {5, 3, 9, 1}, key = 9, sign = -1, i, point, negative;
    ssize_t length;

    for (i = 0; i < 300; i++)
        fputc('a' + i % 26, file);
    fputs("\nshort\n\nlast", file);
    rewind(file);
    while ((length = getline(&line, &size, file)) > 0)
        printf("%d %.5s%c", (int)length, line, line[length - 1] == '\n' ? '\n' : '|');
    printf("%d\n", size > 300);
    rewind(file);
    while ((length = getdelim(&line, &size, 'm', file)) > 0)
        printf("%d ", (int)length);
    printf("\n");
    fclose(file);
    free(line);

    printf("%d", setenv("CRS", "one", 0));
    printf(" %s %d", getenv("CRS"), setenv("CRS", "two", 0));
    printf(" %s %d", getenv("CRS"), setenv("CRS", "three", 1));
    printf(" %s %d\n", getenv("CRS"), putenv("OTHER=4"));
    unsetenv("CRS");
    printf("%s %d %d\n", getenv("OTHER"), getenv("CRS") == NULL, setenv("A=B", "", 1));

    lsearch(&key, numbers, &count, sizeof *numbers, compare);
    key = 7;
    lsearch(&key, numbers, &count, sizeof *numbers, compare);
    printf("%d %d\n", (int)count, lfind(&key, numbers, &count, sizeof *numbers, compare) != NULL);
    qsort_r(numbers, count, sizeof *numbers, compare_by, &sign);
    for (i = 0; i < (int)count; i++)
        printf("%d ", numbers[i]);
    i = mkstemp(name);
    printf("%d %d", i >= 0, (int)strlen(name));
    printf(" %d\n", close(i) + unlink(name));
    printf("%s ", ecvt(3.14159, 4, &point, &negative));
    printf("%d %d ", point, negative);
    printf("%s ", fcvt(-0.00123, 5, &point, &negative));
    printf("%d %d ", point, negative);
    printf("%s\n", gcvt(1234.5, 6, name));
    on_exit(at_end, "ended");
    exit(3);
}
// exit: 3
