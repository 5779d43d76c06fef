/* putchar, puts, fputs, fprintf, fwrite, fputc to both streams; stderr is not in the result. */
#include <stdio.h>

int main(void)
{
    char bytes[] = "raw\0bytes\n";

    putchar('a');
    putc('b', stdout);
    fputc('c', stdout);
    puts("");
    fputs("fputs has no newline|", stdout);
    fprintf(stdout, "%d %s\n", 5, "to stdout");
    fprintf(stderr, "to stderr %d\n", 6);
    fwrite(bytes, 1, 10, stdout);
    fwrite("123456", 2, 3, stdout);
    printf("\n%d\n", putchar('x'));
    printf("%d\n", puts("puts") >= 0);
    fflush(stdout);
    printf("%d %d\n", EOF, printf("") == 0);
    return 0;
}
