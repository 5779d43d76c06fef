/* switch: fall through, default anywhere, negative labels, character labels. */
#include <stdio.h>

static int classify(int n)
{
    switch (n) {
    case -1:
    case -2:
        return -10;
    case 0:
        n = 5;
    case 1:
        n += 100;
        break;
    default:
        n = -n;
    case 7:
        n *= 2;
        break;
    case 8: {
        int n = 3;
        return n;
    }
    }
    return n;
}

static const char *kind(char c)
{
    switch (c) {
    case '0': case '1': case '2': case '3': case '4':
    case '5': case '6': case '7': case '8': case '9':
        return "digit";
    case ' ': case '\t': case '\n':
        return "space";
    case 'a': case 'e': case 'i': case 'o': case 'u':
        return "vowel";
    case '\xe4':
        return "umlaut";
    }
    return "other";
}

int main(void)
{
    int i;

    for (i = -3; i < 10; i++)
        printf("%d ", classify(i));
    printf("\n");
    printf("%s %s %s %s %s\n", kind('7'), kind('\t'), kind('e'), kind('z'), kind((char) 0xe4));
    switch (3)
        printf("skipped\n");
    switch (i)
    default:
        printf("only default\n");
    switch (1 ? i : 2) { }
    switch (i > 5) {
    case 1: printf("bigger\n");
    }
    return 0;
}
