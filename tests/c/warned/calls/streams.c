/* Missing or misplaced stream and format arguments. */
#include <stdio.h>

int main(void)
{
    FILE *log = stdout;
    char line[20];
    int speed = 3;

    fprintf("fast\n", "now"); // warning: 'fprintf' takes the stream as its first argument, such as
//          ^
    fputs(log, 0); // warning: 'fputs' takes the stream as its last argument
    fgets(line, 20, line); // warning: 'fgets' takes the stream as its last argument, such as
    fclose("log.txt"); // warning: 'fclose' takes a stream, such as stdout or the result of fopen
    printf(stderr, "fast\n"); // warning: for a stream use 'fprintf'
    printf(speed); // warning: the format comes first: printf("%d", ...)
    sprintf(line, speed); // warning: 'sprintf' takes the format as its second argument
    return 0;
}
