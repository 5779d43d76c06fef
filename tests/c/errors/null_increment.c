/* Reading and writing in one operator. */
static long long *counter;

int main(void)
{
    ++*counter; // error: null pointer
    return 0;
}
