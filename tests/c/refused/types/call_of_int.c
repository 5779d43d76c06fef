/* A call of something that is no function. */
int main(void)
{
    int n = 5;

    return n(3); // error: function
}
