/* Is steered by keys: waits for each at most a second. */
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

int main(void)
{
    struct pollfd keys = {0, POLLIN, 0};
    int waits = 0, presses = 0;
    char key = 0;

    while (key != 'q') {
        if (poll(&keys, 1, 1000) == 0) {
            waits++;
            continue;
        }
        read(0, &key, 1);
        presses++;
        printf("%c\n", key);
    }
    return 0;
}
