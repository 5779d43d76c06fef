/* Threads are not supported. */
#include <threads.h> // error: 'threads.h' file not found

int main(void)
{
    return 0;
}
