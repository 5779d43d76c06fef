/* Functions of a program whose names the library has for something else, as in old books. */
// without gcc: its headers let no program declare getline, select and malloc otherwise
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int getline(char line[], int most);
static int select(int, int);
char *malloc();

int getline(char line[], int most)
{
    strncpy(line, "a line of our own", most);
    return strlen(line);
}

static int select(int left, int right)
{
    return left > right ? left : right;
}

static double drem(double x)
{
    return x - floor(x);
}

void error(text)
char *text;
{
    printf("error: %s\n", text);
}

int main(void)
{
    char line[40];

    printf("%d %s\n", getline(line, sizeof line), line);
    printf("%d %g\n", select(3, 9), drem(2.75));
    error("no error");
    return malloc(3) == NULL;
}
